package java.io;

import lejos.nxt.Flash;

/** Reads a file. */
public class FileInputStream extends InputStream {
    private final byte[] buffer = new byte[Flash.BYTES_PER_PAGE];
    private final int first;
    private final int size;
    private int place;
    private int buffered = -1;

    /** Opens the file. */
    public FileInputStream(File file) throws FileNotFoundException {
        if (!file.exists()) throw new FileNotFoundException(file + " does not exist");
        first = file.page;
        size = file.size;
    }

    /** Gives the next byte, 0 to 255, or -1 if there are no more. */
    public int read() throws IOException {
        if (place >= size) return -1;
        int page = place / Flash.BYTES_PER_PAGE;
        if (page != buffered) {
            Flash.readPage(buffer, first + page);
            buffered = page;
        }
        return buffer[place++ % Flash.BYTES_PER_PAGE] & 0xFF;
    }

    /** Reads at most so many bytes into the array, from a place on, and gives how many, or -1. */
    public int read(byte[] bytes, int offset, int length) throws IOException {
        if (place >= size) return -1;
        int count = Math.min(length, size - place);
        for (int index = 0; index < count; index++) bytes[offset + index] = (byte) read();
        return count;
    }

    /** Skips at most so many bytes; a brick gives how many of them it could not skip. */
    public long skip(long count) throws IOException {
        if (count <= 0) return 0;
        int skipped = (int) Math.min(count, size - place);
        place += skipped;
        return count - skipped;
    }

    /** Gives how many bytes are left. */
    public int available() throws IOException {
        return size - place;
    }
}
