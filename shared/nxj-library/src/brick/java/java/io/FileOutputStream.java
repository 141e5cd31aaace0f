package java.io;

/** Writes a file. */
public class FileOutputStream extends OutputStream {
    private final File file;

    /** Begins the file anew. */
    public FileOutputStream(File file) {
        this(file, false);
    }

    /** Opens the file, and says whether to go on behind what it has. */
    public FileOutputStream(File file, boolean append) {
        File present = append ? file.find() : null;
        this.file = present == null ? file.create() : present;
    }

    /** Writes a byte: the lowest eight bits of the number. */
    public void write(int value) throws IOException {
        file.append(value);
    }
}
