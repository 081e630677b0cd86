% The degenerate octant as a surface of revolution, premultiplied; the product of two quarter circles.
h = sqrt(2)/2;
coefs = 0;                        % a scalar that is not used
coefs(:,:,1) = [0 0 0; 0 0 0; -1 -h -1; 1 h 1];
coefs(:,:,2) = [h, 1/2, 0; ...    % i runs along a row
                0, 1/2, h; -h, -1/2, -h; h, 1/2, h];
coefs(:,:,3) = [1 h 0
                0 h 1
                0 0 0
                1 h 1];
