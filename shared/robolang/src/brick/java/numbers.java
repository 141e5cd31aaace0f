//// ROUND_HALF_UP

/** The nearest whole number, a half upwards. */
static int roundHalfUp(float value) {
    int below = (int) value;
    return value - below >= 0.5f && below < 2147483647 ? below + 1 : below;
}

//// REMAINDER

/** What is left of a division without a fraction: the brick has no % for decimal numbers. */
static float remainder(float left, float right) {
    return left - right * (int) (left / right);
}

//// DICE

/** The brick's clock decides which numbers it throws. */
static final Random dice = new Random((int) System.currentTimeMillis() / 64);

//// RANDOM

/** A whole number from one to another, both included. */
static int random(int first, int last) {
    int smaller = Math.min(first, last);
    int count = Math.max(first, last) - smaller + 1;
    if (count <= 0) return dice.nextInt();
    int rest = dice.nextInt() % count;
    return smaller + (rest < 0 ? rest + count : rest);
}

//// RANDOM_DECIMAL

/** A decimal number from one to another. */
static float random(float first, float last) {
    return first + (last - first) * ((dice.nextInt() & 0xFFFFFF) / 16777216f);
}

//// FLOOR

/** The whole number below. */
static int floor(float value) {
    int truncated = (int) value;
    return truncated > value ? truncated - 1 : truncated;
}

//// CEIL

/** The whole number above. */
static int ceil(float value) {
    int truncated = (int) value;
    return truncated < value && truncated < 2147483647 ? truncated + 1 : truncated;
}

//// ROUND

/** The nearest whole number, a half upwards. */
static int round(float value) {
    int below = floor(value);
    return value - below >= 0.5f && below < 2147483647 ? below + 1 : below;
}

//// SQRT

/** The square root. */
static float sqrt(float value) {
    return (float) Math.sqrt(value);
}
