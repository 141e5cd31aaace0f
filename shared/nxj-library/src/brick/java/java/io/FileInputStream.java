package java.io;

/** Reads a file. */
public class FileInputStream extends InputStream {
    private final File file;
    private int place;

    /** Opens the file. */
    public FileInputStream(File file) throws FileNotFoundException {
        this.file = file.find();
        if (this.file == null) throw new FileNotFoundException(file.getName());
    }

    /** Gives the next byte, 0 to 255, or -1 if there are no more. */
    public int read() throws IOException {
        return place < file.length ? file.bytes[place++] & 0xFF : -1;
    }

    /** Gives how many bytes are left. */
    public int available() throws IOException {
        return file.length - place;
    }
}
