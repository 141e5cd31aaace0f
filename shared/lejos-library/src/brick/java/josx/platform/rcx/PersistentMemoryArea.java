package josx.platform.rcx;

/**
 * Bytes that the brick remembers while it is switched off, and until another program is loaded.
 *
 * <p>Get them at the beginning of a program: they are the front of the memory for objects.
 */
public class PersistentMemoryArea {
    // How the brick's memory for objects looks. At its beginning is the address of its end, then the first block. A free block begins with its
    // size in words of two bytes, an array with two bytes that say so, and two more. An array of int is what the bytes are to the brick.
    private static final int REGION_HEADER = 2;
    private static final int ARRAY_HEADER = 4;
    private static final int WORD = 2;
    private static final int IS_TAKEN = 0x8000;
    private static final int IS_ARRAY = 0x4000;
    private static final int INT_ARRAY = 10 << 9;
    private static final int INT_SIZE = 4;
    private static final int MOST_INTS = 511;

    /** The magic number and the size, two bytes each, go before the bytes. */
    private static final int OWN_HEADER = 4;

    private static PersistentMemoryArea only;

    private final int first;
    private final int size;

    private PersistentMemoryArea(int first, int size) {
        this.first = first;
        this.size = size;
    }

    /** Gives the bytes of the last time if magic number and size are the same as then, otherwise as many zeros. */
    public static PersistentMemoryArea get(int magic, int size) {
        synchronized (Memory.MONITOR) {
            if (only == null) only = new PersistentMemoryArea(reserve(magic, size), size);
            return only;
        }
    }

    /** Takes the bytes from the first free block and gives the address of the first one. */
    private static int reserve(int magic, int size) {
        int block = getRegionAddress() + REGION_HEADER;
        int free = Memory.readShort(block);
        int ints = (size + OWN_HEADER + INT_SIZE - 1) / INT_SIZE;
        int words = (ARRAY_HEADER + ints * INT_SIZE) / WORD;
        if (size < 0 || ints > MOST_INTS || (free & IS_TAKEN) != 0 || words > free) throw new OutOfMemoryError();
        if (words < free) Memory.writeShort(block + words * WORD, (short) (free - words));
        Memory.writeShort(block, (short) (IS_TAKEN | IS_ARRAY | INT_ARRAY | ints));
        int magicAddress = block + ARRAY_HEADER;
        int sizeAddress = magicAddress + WORD;
        int first = magicAddress + OWN_HEADER;
        if (Memory.readShort(magicAddress) != (short) magic || Memory.readShort(sizeAddress) != (short) size) {
            for (int index = 0; index < size; index++) Memory.writeByte(first + index, (byte) 0);
            Memory.writeShort(magicAddress, (short) magic);
            Memory.writeShort(sizeAddress, (short) size);
        }
        return first;
    }

    /** Gives the byte at a place; the first one is at place 0. */
    public byte readByte(int place) {
        check(place);
        return Memory.readByte(first + place);
    }

    /** Changes the byte at a place. */
    public void writeByte(int place, byte value) {
        check(place);
        Memory.writeByte(first + place, value);
    }

    private void check(int place) {
        if (place < 0 || place >= size) throw new ArrayIndexOutOfBoundsException();
    }

    /** Where the memory for objects begins. */
    private static native int getRegionAddress();
}
