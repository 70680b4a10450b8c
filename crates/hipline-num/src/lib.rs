//! Exact signs and correctly rounded values of polynomials in square roots.
