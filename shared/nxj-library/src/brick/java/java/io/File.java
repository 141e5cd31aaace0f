package java.io;

import java.util.Vector;

/** A file of the brick; what is written here is kept until the program ends. */
public class File {
    private static final Vector<File> files = new Vector<File>();

    private final String name;

    // The content, in the file of that name that exists.
    byte[] bytes = new byte[0];
    int length;

    /** Makes one with the name; the file need not exist. */
    public File(String name) {
        this.name = name;
    }

    /** Gives all files, with null behind the last one. */
    public static File[] listFiles() {
        synchronized (files) {
            File[] all = new File[files.size() + 1];
            files.copyInto(all);
            return all;
        }
    }

    /** Gives the name. */
    public String getName() {
        return name;
    }

    /** Says whether the file exists. */
    public boolean exists() {
        return find() != null;
    }

    /** Makes an empty file, and says whether there was none. */
    public boolean createNewFile() throws IOException {
        synchronized (files) {
            if (find() != null) return false;
            create();
            return true;
        }
    }

    /** Removes the file, and says whether there was one. */
    public boolean delete() {
        synchronized (files) {
            return files.removeElement(find());
        }
    }

    /** Gives the number of bytes. */
    public long length() {
        File file = find();
        return file == null ? 0 : file.length;
    }

    /** Says whether the file can be read. */
    public boolean canRead() {
        return exists();
    }

    /** Says whether the file can be written. */
    public boolean canWrite() {
        return true;
    }

    /**
     * Says that it is no folder.
     *
     * @hidden
     */
    public boolean isDirectory() {
        return false;
    }

    /** Says whether both have the same name. */
    public boolean equals(Object other) {
        return other instanceof File && ((File) other).name.equals(name);
    }

    /** Gives a number that is the same for the same name. */
    public int hashCode() {
        return name.hashCode();
    }

    /** Gives the name. */
    public String toString() {
        return name;
    }

    File find() {
        synchronized (files) {
            int index = files.indexOf(this);
            return index < 0 ? null : files.elementAt(index);
        }
    }

    File create() {
        synchronized (files) {
            files.removeElement(this);
            File file = new File(name);
            files.addElement(file);
            return file;
        }
    }

    void append(int value) {
        if (length == bytes.length) {
            byte[] larger = new byte[2 * length + 32];
            System.arraycopy(bytes, 0, larger, 0, length);
            bytes = larger;
        }
        bytes[length++] = (byte) value;
    }
}
