% Two quarter circles; the weight of one point is missing.
h = sqrt(2)/2;
c(:,:,1) = [0 0 0; 0 0 0; -1 -h -1; 1 h 1];
c(:,:,2) = [h 1/2 0; 0 1/2 h; -h -1/2 -h; h 1/2 1];
c(:,:,3) = [1 h 0; 0 h 1; 0 0 0; 1 h 1];
