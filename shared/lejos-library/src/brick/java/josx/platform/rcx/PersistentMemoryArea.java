package josx.platform.rcx;

/** Bytes that the brick remembers while it is switched off. */
public class PersistentMemoryArea {
    // Behind the data of the ROM; a magic number and the size go before the bytes.
    private static final int MAGIC_ADDRESS = 0xF004;
    private static final int SIZE_ADDRESS = MAGIC_ADDRESS + 2;
    private static final int FIRST_ADDRESS = MAGIC_ADDRESS + 4;
    private static final int MOST_BYTES = 511 * 4 - 4;

    private static PersistentMemoryArea only;

    private final int size;

    private PersistentMemoryArea(int size) {
        this.size = size;
    }

    /** Gives the bytes of the last time if the magic number is the same as then, otherwise as many zeros. */
    public static PersistentMemoryArea get(int magic, int size) {
        synchronized (Memory.MONITOR) {
            if (only != null) return only;
            if (size < 0 || size > MOST_BYTES) throw new OutOfMemoryError();
            if (Memory.readShort(MAGIC_ADDRESS) != (short) magic || Memory.readShort(SIZE_ADDRESS) != (short) size) {
                for (int index = 0; index < size; index++) Memory.writeByte(FIRST_ADDRESS + index, (byte) 0);
                Memory.writeShort(MAGIC_ADDRESS, (short) magic);
                Memory.writeShort(SIZE_ADDRESS, (short) size);
            }
            only = new PersistentMemoryArea(size);
            return only;
        }
    }

    /** Gives the byte at a place; the first one is at place 0. */
    public byte readByte(int place) {
        check(place);
        return Memory.readByte(FIRST_ADDRESS + place);
    }

    /** Changes the byte at a place. */
    public void writeByte(int place, byte value) {
        check(place);
        Memory.writeByte(FIRST_ADDRESS + place, value);
    }

    private void check(int place) {
        if (place < 0 || place >= size) throw new ArrayIndexOutOfBoundsException();
    }
}
