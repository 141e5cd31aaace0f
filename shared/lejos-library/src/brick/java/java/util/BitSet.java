package java.util;

/** A row of yes and no, eight of them in a byte. */
public class BitSet {
    private final byte[] bytes;

    /** Makes a row of so many, all no. */
    public BitSet(int count) {
        bytes = new byte[(count + 7) / 8];
    }

    /** Makes one of them yes. */
    public void set(int place) {
        bytes[place >> 3] |= 1 << (place & 7);
    }

    /** Makes one of them no. */
    public void clear(int place) {
        bytes[place >> 3] &= ~(1 << (place & 7));
    }

    /** Says whether one of them is yes. */
    public boolean get(int place) {
        return (bytes[place >> 3] & 1 << (place & 7)) != 0;
    }
}
