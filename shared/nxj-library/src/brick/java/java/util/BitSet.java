package java.util;

/** Many values that are true or false, each with a number from 0 on. */
public class BitSet {
    private int[] words;

    /** Makes one in which all values are false. */
    public BitSet() {
        this(32);
    }

    /** Makes one with room for so many values; it grows as needed. */
    public BitSet(int count) {
        if (count < 0) throw new NegativeArraySizeException();
        words = new int[count + 31 >> 5];
    }

    /** Gives a value. */
    public boolean get(int index) {
        check(index);
        return index >> 5 < words.length && (words[index >> 5] & 1 << index) != 0;
    }

    /** Makes a value true. */
    public void set(int index) {
        check(index);
        growTo((index >> 5) + 1);
        words[index >> 5] |= 1 << index;
    }

    /** Makes a value true or false. */
    public void set(int index, boolean value) {
        if (value) {
            set(index);
        } else {
            clear(index);
        }
    }

    /** Makes a value false. */
    public void clear(int index) {
        check(index);
        if (index >> 5 < words.length) words[index >> 5] &= ~(1 << index);
    }

    /** Makes all values false. */
    public void clear() {
        for (int place = 0; place < words.length; place++) words[place] = 0;
    }

    /** Makes a value true if it is false, and false if it is true. */
    public void flip(int index) {
        set(index, !get(index));
    }

    /**
     * Leaves only those values true that are true in both.
     *
     * @hidden
     */
    public void and(BitSet other) {
        for (int place = 0; place < words.length; place++) words[place] &= other.word(place);
    }

    /**
     * Makes those values false that are true in the other one.
     *
     * @hidden
     */
    public void andNot(BitSet other) {
        for (int place = 0; place < words.length; place++) words[place] &= ~other.word(place);
    }

    /**
     * Makes those values true that are true in the other one.
     *
     * @hidden
     */
    public void or(BitSet other) {
        growTo(other.words.length);
        for (int place = 0; place < words.length; place++) words[place] |= other.word(place);
    }

    /**
     * Makes those values true that are true in only one of both, and all others false.
     *
     * @hidden
     */
    public void xor(BitSet other) {
        growTo(other.words.length);
        for (int place = 0; place < words.length; place++) words[place] ^= other.word(place);
    }

    /**
     * Says whether a value is true in both.
     *
     * @hidden
     */
    public boolean intersects(BitSet other) {
        for (int place = 0; place < words.length; place++) {
            if ((words[place] & other.word(place)) != 0) return true;
        }
        return false;
    }

    /** Gives how many values are true. */
    public int cardinality() {
        int count = 0;
        for (int place = 0; place < words.length; place++) count += Integer.bitCount(words[place]);
        return count;
    }

    /** Says whether no value is true. */
    public boolean isEmpty() {
        return length() == 0;
    }

    /** Gives one more than the last number of a true value; 0 if there is none. */
    public int length() {
        for (int place = words.length - 1; place >= 0; place--) {
            if (words[place] != 0) return 32 * place + 32 - Integer.numberOfLeadingZeros(words[place]);
        }
        return 0;
    }

    /** Gives for how many values there is room. */
    public int size() {
        return 32 * words.length;
    }

    /**
     * Gives the first true value from a number on, or -1 if there is none.
     *
     * @hidden
     */
    public int nextSetBit(int index) {
        check(index);
        for (int next = index; next < size(); next++) {
            if (get(next)) return next;
        }
        return -1;
    }

    /**
     * Gives the first false value from a number on.
     *
     * @hidden
     */
    public int nextClearBit(int index) {
        int next = index;
        while (get(next)) next++;
        return next;
    }

    /** Says whether the same values are true in both. */
    public boolean equals(Object other) {
        if (!(other instanceof BitSet)) return false;
        BitSet set = (BitSet) other;
        int count = words.length > set.words.length ? words.length : set.words.length;
        for (int place = 0; place < count; place++) {
            if (word(place) != set.word(place)) return false;
        }
        return true;
    }

    /** Gives a number that is the same if the same values are true. */
    public int hashCode() {
        int hash = 0;
        for (int place = words.length - 1; place >= 0; place--) hash = 31 * hash + words[place];
        return hash;
    }

    /** Gives the numbers of the true values as text. */
    public String toString() {
        StringBuilder text = new StringBuilder("{");
        for (int index = nextSetBit(0); index >= 0; index = nextSetBit(index + 1)) {
            if (text.length() > 1) text.append(", ");
            text.append(index);
        }
        return text.append('}').toString();
    }

    private int word(int place) {
        return place < words.length ? words[place] : 0;
    }

    private void growTo(int count) {
        if (count <= words.length) return;
        int[] larger = new int[count];
        System.arraycopy(words, 0, larger, 0, words.length);
        words = larger;
    }

    private static void check(int index) {
        if (index < 0) throw new IndexOutOfBoundsException();
    }
}
