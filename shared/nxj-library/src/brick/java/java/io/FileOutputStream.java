package java.io;

import lejos.nxt.Flash;

/** Writes a file; close it, or its last bytes and its length are lost. */
public class FileOutputStream extends OutputStream {
    private final File file;
    private byte[] buffer = new byte[Flash.BYTES_PER_PAGE];
    private int page;
    private int place;

    /** Begins the file anew. */
    public FileOutputStream(File file) throws FileNotFoundException {
        this(file, false);
    }

    /** Opens the file, and says whether to go on behind what it has. */
    public FileOutputStream(File file, boolean append) throws FileNotFoundException {
        this.file = file;
        if (!append && file.exists()) file.delete();
        try {
            file.createNewFile();
        } catch (IOException full) {
            throw new FileNotFoundException("file could not be created");
        }
        if (append) {
            page = file.page + file.size / Flash.BYTES_PER_PAGE;
            place = file.size % Flash.BYTES_PER_PAGE;
            Flash.readPage(buffer, page);
        } else {
            page = file.page;
            file.size = 0;
        }
    }

    /** Writes a byte: the lowest eight bits of the number. */
    public void write(int value) throws IOException {
        checkOpen();
        buffer[place++] = (byte) value;
        file.size++;
        if (place >= Flash.BYTES_PER_PAGE) {
            flush();
            page++;
            place = 0;
        }
    }

    /** Writes what was kept back; the file becomes the last one. */
    public void flush() throws IOException {
        checkOpen();
        if (file.getIndex() < File.totalFiles - 1) {
            int before = file.page;
            file.moveToTop();
            page += file.page - before;
        }
        Flash.writePage(buffer, page);
    }

    /** Writes what was kept back, and the length of the file. */
    public void close() throws IOException {
        if (buffer == null) return;
        flush();
        File.writeTable();
        buffer = null;
    }

    private void checkOpen() throws IOException {
        if (buffer == null) throw new IOException("stream is closed");
    }
}
