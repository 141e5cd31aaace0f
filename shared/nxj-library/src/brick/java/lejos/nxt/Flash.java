package lejos.nxt;

/** The memory that keeps files while the brick is switched off, page by page; programs rather use java.io.File. */
public class Flash {
    /** How many bytes a page has. */
    public static final int BYTES_PER_PAGE = 256;

    /** How many pages there are. */
    public static final int MAX_USER_PAGES = 512;

    private Flash() {
    }

    /** Reads a page into an array of at least 256 bytes; fails with FlashError if there is no such page. */
    public static void readPage(byte[] bytes, int page) {
        if (flashReadPage(bytes, page) < 0) throw new FlashError("flash read failed");
    }

    /** Writes the first 256 bytes of an array to a page; fails with FlashError if there is no such page. */
    public static void writePage(byte[] bytes, int page) {
        if (flashWritePage(bytes, page) < 0) throw new FlashError("flash write failed");
    }

    private static native int flashReadPage(byte[] bytes, int page);

    private static native int flashWritePage(byte[] bytes, int page);
}
