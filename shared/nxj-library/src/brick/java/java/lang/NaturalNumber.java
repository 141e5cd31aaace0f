package java.lang;

/** A whole number from 0 up, as large as needed, which changes; used to turn decimal numbers into texts and back. */
final class NaturalNumber {
    private static final long WORD = 0xFFFFFFFFL;
    private static final int BILLION = 1000000000;

    /** The number in words of 32 bits, the lowest first. */
    private int[] words = new int[4];

    /** How many words there are; the last of them is not 0. */
    private int length;

    NaturalNumber(long value) {
        words[0] = (int) value;
        words[1] = (int) (value >>> 32);
        length = 2;
        trim();
    }

    NaturalNumber copy() {
        NaturalNumber copy = new NaturalNumber(0);
        copy.growTo(length);
        System.arraycopy(words, 0, copy.words, 0, length);
        copy.length = length;
        return copy;
    }

    boolean isZero() {
        return length == 0;
    }

    int bitLength() {
        return length == 0 ? 0 : 32 * length - Integer.numberOfLeadingZeros(words[length - 1]);
    }

    /** Multiplies by a factor and adds a number, both of at most 31 bits. */
    void multiply(int factor, int added) {
        long carry = added;
        for (int index = 0; index < length; index++) {
            carry += (words[index] & WORD) * factor;
            words[index] = (int) carry;
            carry >>>= 32;
        }
        if (carry != 0) {
            growTo(length + 1);
            words[length++] = (int) carry;
        }
    }

    void multiplyByPowerOf10(int power) {
        int rest = power;
        for (; rest >= 9; rest -= 9) multiply(BILLION, 0);
        for (; rest > 0; rest--) multiply(10, 0);
    }

    void shiftLeft(int bits) {
        if (length == 0 || bits == 0) return;
        int places = bits >> 5;
        int shift = bits & 31;
        growTo(length + places + 1);
        words[length + places] = 0;
        for (int index = length - 1; index >= 0; index--) {
            long word = (words[index] & WORD) << shift;
            words[index] = 0;
            words[index + places + 1] |= (int) (word >>> 32);
            words[index + places] = (int) word;
        }
        length += places + 1;
        trim();
    }

    int compareTo(NaturalNumber other) {
        if (length != other.length) return length < other.length ? -1 : 1;
        for (int index = length - 1; index >= 0; index--) {
            long own = words[index] & WORD;
            long others = other.words[index] & WORD;
            if (own != others) return own < others ? -1 : 1;
        }
        return 0;
    }

    /** Compares the sum of this and a second number with a third one. */
    int compareSumTo(NaturalNumber second, NaturalNumber third) {
        NaturalNumber sum = new NaturalNumber(0);
        int count = length > second.length ? length : second.length;
        sum.growTo(count + 1);
        long carry = 0;
        for (int index = 0; index < count; index++) {
            if (index < length) carry += words[index] & WORD;
            if (index < second.length) carry += second.words[index] & WORD;
            sum.words[index] = (int) carry;
            carry >>>= 32;
        }
        sum.words[count] = (int) carry;
        sum.length = count + 1;
        sum.trim();
        return sum.compareTo(third);
    }

    /** Subtracts a number that is not larger. */
    void subtract(NaturalNumber other) {
        long carry = 0;
        for (int index = 0; index < length; index++) {
            carry += words[index] & WORD;
            if (index < other.length) carry -= other.words[index] & WORD;
            words[index] = (int) carry;
            carry >>= 32;
        }
        trim();
    }

    private void growTo(int count) {
        if (count <= words.length) return;
        int[] larger = new int[count + 4];
        System.arraycopy(words, 0, larger, 0, length);
        words = larger;
    }

    private void trim() {
        while (length > 0 && words[length - 1] == 0) length--;
    }
}
