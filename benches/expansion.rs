fn main(){ divan::main() }
