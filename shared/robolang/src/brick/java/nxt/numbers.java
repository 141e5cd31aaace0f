//// REMAINDER

/** What is left of a division without a fraction. */
static float remainder(float left, float right) {
    return left - right * (int) (left / right);
}
