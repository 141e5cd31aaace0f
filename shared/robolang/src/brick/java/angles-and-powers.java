//// QUARTER_SINE

/** Sine of an angle up to an eighth of a turn, in radians. */
static float sineOfSmall(float x) {
    float square = x * x;
    return x * (1f - square / 6f * (1f - square / 20f * (1f - square / 42f * (1f - square / 72f))));
}

/** Cosine of an angle up to an eighth of a turn, in radians. */
static float cosineOfSmall(float x) {
    float square = x * x;
    return 1f - square / 2f * (1f - square / 12f * (1f - square / 30f * (1f - square / 56f)));
}

//// SIN

/** Sine of an angle in degrees. */
static float sin(float degrees) {
    if (!(degrees > -16777216f && degrees < 16777216f)) return 0f;
    int quarters = round(degrees / 90f);
    float rest = (degrees - quarters * 90f) * 0.017453292f;
    int quarter = quarters & 3;
    if (quarter == 0) return sineOfSmall(rest);
    if (quarter == 1) return cosineOfSmall(rest);
    if (quarter == 2) return -sineOfSmall(rest);
    return -cosineOfSmall(rest);
}

//// COS

/** Cosine of an angle in degrees. */
static float cos(float degrees) {
    if (!(degrees > -16777216f && degrees < 16777216f)) return 1f;
    int quarters = round(degrees / 90f);
    float rest = (degrees - quarters * 90f) * 0.017453292f;
    int quarter = quarters & 3;
    if (quarter == 0) return cosineOfSmall(rest);
    if (quarter == 1) return -sineOfSmall(rest);
    if (quarter == 2) return -cosineOfSmall(rest);
    return sineOfSmall(rest);
}

//// TAN

/** Tangent of an angle in degrees. */
static float tan(float degrees) {
    return sin(degrees) / cos(degrees);
}

//// ATAN2

/** The direction, in degrees, of a point so far up and so far to the right. */
static float atan2(float y, float x) {
    float right = x < 0f ? -x : x;
    float up = y < 0f ? -y : y;
    float angle;
    if (right == 0f && up == 0f) {
        angle = 0f;
    } else if (up <= right) {
        angle = arcOf(up / right);
    } else {
        angle = 90f - arcOf(right / up);
    }
    float upper = x < 0f ? 180f - angle : angle;
    return y < 0f ? -upper : upper;
}

/** The angle, in degrees, whose tangent is t, from 0 to 1. */
static float arcOf(float t) {
    return t > 0.41421357f ? 45f + smallArcOf((t - 1f) / (t + 1f)) : smallArcOf(t);
}

static float smallArcOf(float t) {
    float square = t * t;
    float sum = 0f;
    for (int divisor = 15; divisor >= 1; divisor -= 2) sum = 1f / divisor - square * sum;
    return t * sum * 57.29578f;
}

//// POW

/** A number to the power of another. */
static float pow(float base, float exponent) {
    int whole = (int) exponent;
    if ((float) whole == exponent) return wholePower(base, whole);
    if (base == 0f) return exponent > 0f ? 0f : 1f / base;
    return powerOfTwo(exponent * logarithmToBase2(base));
}

static float wholePower(float base, int exponent) {
    float factor = base;
    int rest = exponent < 0 ? -exponent : exponent;
    float product = 1f;
    while (rest != 0) {
        if ((rest & 1) == 1) product *= factor;
        factor *= factor;
        rest = rest >>> 1;
    }
    return exponent < 0 ? 1f / product : product;
}

static float logarithmToBase2(float value) {
    if (value > 3.4028235e38f || value != value) return value;
    float mantissa = value;
    int exponent = 0;
    while (mantissa > 1.4142135f) {
        mantissa /= 2f;
        exponent++;
    }
    while (mantissa < 1.4142135f / 2f) {
        mantissa *= 2f;
        exponent--;
    }
    float s = (mantissa - 1f) / (mantissa + 1f);
    float square = s * s;
    float sum = 0f;
    for (int divisor = 9; divisor >= 1; divisor -= 2) sum = 1f / divisor + square * sum;
    return exponent + 2f * s * sum / 0.6931472f;
}

static float powerOfTwo(float exponent) {
    if (exponent != exponent) return exponent;
    float limited = exponent < -160f ? -160f : exponent > 160f ? 160f : exponent;
    int whole = round(limited);
    float x = (limited - whole) * 0.6931472f;
    float result = 1f;
    for (int divisor = 7; divisor >= 1; divisor--) result = 1f + x / divisor * result;
    for (int step = whole < 0 ? -whole : whole; step > 0; step--) result = whole < 0 ? result / 2f : result * 2f;
    return result;
}
