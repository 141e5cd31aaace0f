package java.lang;

/** A number as the sum of a double and a much smaller one, with about 106 bits; what Math works with in between. */
final class TwoPartNumber {
    double high;
    double low;

    /** For an angle: how many quarters of a turn were taken from it. */
    int quarters;

    TwoPartNumber() {
    }

    /** Sets the exact sum of two numbers, and adds a small one to it. */
    void setSum(double a, double b, double small) {
        double sum = a + b;
        double part = sum - a;
        low = a - (sum - part) + (b - part) + small;
        high = sum;
    }

    /** Sets the exact product of two numbers, and adds a small one to it. */
    void setProduct(double a, double b, double small) {
        double product = a * b;
        low = remainder(a, b, product) + small;
        high = product;
    }

    /** What is missing from the rounded product of two numbers. */
    static double remainder(double a, double b, double product) {
        double highA = upperBits(a);
        double highB = upperBits(b);
        double lowA = a - highA;
        double lowB = b - highB;
        return highA * highB - product + highA * lowB + lowA * highB + lowA * lowB;
    }

    /** The first 26 bits, so that the product of two such numbers is exact. */
    static double upperBits(double number) {
        return Double.longBitsToDouble(Double.doubleToRawLongBits(number) & 0xFFFFFFFFF8000000L);
    }
}
