package java.io;

import lejos.nxt.Flash;

/**
 * A file in the flash memory of the brick, which keeps it after the program.
 *
 * <p>There are no folders. A brick has at most 30 files, as many as their table has room for: 256 bytes, of which each
 * takes 8 and its name, which has at most 30 characters. A file that is written becomes the last one.
 */
public class File {
    /** How many files a brick can have. */
    public static final byte MAX_FILES = 30;

    /** How many files there are; below 0 before that is known. */
    public static byte totalFiles = -1;

    private static final String SIGN = "V_0.4";
    private static final int TABLE_PAGE = 1;
    private static final int FIRST_PAGE = 3;
    private static final int LONGEST_NAME = 30;
    private static final int READ_ONLY = 1;
    private static final int HIDDEN = 2;

    private static final byte[] buffer = new byte[Flash.BYTES_PER_PAGE];
    private static File[] files;
    private static int place;

    int page = -1;
    int size;
    private final String name;
    private boolean isThere;
    private int attributes;

    /** Makes one with the name; the file need not exist. */
    public File(String name) {
        if (!hasTable()) format();
        this.name = name;
        known();
        for (int index = 0; index < totalFiles; index++) {
            if (files[index].name.equals(name)) {
                size = files[index].size;
                page = files[index].page;
                isThere = true;
                files[index] = this;
            }
        }
    }

    private File(String name, int page, int size, int attributes) {
        this.name = name;
        this.page = page;
        this.size = size;
        this.attributes = attributes;
        isThere = true;
    }

    /** Gives an array for 30 files: all that there are, the oldest first, and null behind the last one. */
    public static File[] listFiles() {
        return known();
    }

    /** Gives the bytes behind the last file; those between files do not count. */
    public static int freeMemory() {
        known();
        int last = -1;
        if (totalFiles > 0) {
            File top = files[totalFiles - 1];
            last = top.page + (top.size - 1) / Flash.BYTES_PER_PAGE;
        }
        return (Flash.MAX_USER_PAGES - 1 - last) * Flash.BYTES_PER_PAGE;
    }

    /** Removes all files. */
    public static void format() {
        for (int index = 0; index < SIGN.length(); index++) buffer[index] = (byte) SIGN.charAt(index);
        buffer[SIGN.length()] = 0;
        Flash.writePage(buffer, TABLE_PAGE);
        files = null;
    }

    /** Moves all files together, so that what is free is behind them. */
    public static void defrag() throws IOException {
        known();
        int free = FIRST_PAGE;
        for (int index = 0; index < totalFiles; index++) {
            File file = files[index];
            if (file.page > free) file.moveTo(free);
            free = file.page + pagesOf(file.size);
        }
        writeTable();
    }

    /** Lets the table of files be read again. */
    public static void reset() {
        files = null;
    }

    /** Gives the name. */
    public String getName() {
        return name;
    }

    /** Gives the number of bytes; 0 if there is no such file. */
    public long length() {
        return size;
    }

    /** Says whether there is such a file. */
    public boolean exists() {
        return isThere;
    }

    /** Says true: every file can be read. */
    public boolean canRead() {
        return true;
    }

    /** Says whether setReadOnly was not called; a brick writes the file all the same. */
    public boolean canWrite() {
        return (attributes & READ_ONLY) == 0;
    }

    /** Says whether the file is hidden. */
    public boolean isHidden() {
        return (attributes & HIDDEN) != 0;
    }

    /** Marks the file as one that is only to be read, and says true. */
    public boolean setReadOnly() {
        attributes |= READ_ONLY;
        return true;
    }

    /** Gives the page where the file begins; below 0 if it was never there. */
    public int getPage() {
        return page;
    }

    /** Gives the place among all files, or their number if it is not there. */
    public int getIndex() {
        int index = 0;
        while (index < totalFiles && files[index] != this) index++;
        return index;
    }

    /** Makes an empty file, and says whether there was none; fails with IOException if the table of files is full. */
    public boolean createNewFile() throws IOException {
        if (isThere) return false;
        known();
        page = FIRST_PAGE;
        if (totalFiles > 0) {
            File top = files[totalFiles - 1];
            page = top.page + pagesOf(Math.max(1, top.size));
        }
        files[totalFiles] = this;
        writeTable();
        isThere = true;
        return true;
    }

    /** Removes the file, and says whether there was one. */
    public boolean delete() {
        if (!isThere) return false;
        int index = -1;
        for (int other = 0; other < totalFiles; other++) {
            if (files[other].name.equals(name)) index = other;
        }
        totalFiles--;
        if (files[index + 1] == null) {
            files[index] = null;
        } else {
            for (; index <= totalFiles; index++) files[index] = files[index + 1];
        }
        try {
            writeTable();
        } catch (IOException impossible) {
            // The table becomes shorter.
        }
        isThere = false;
        size = 0;
        return true;
    }

    /** Makes the file the last one, behind which there is room. */
    public void moveToTop() throws IOException {
        File top = files[totalFiles - 1];
        int length = size;
        moveTo(1 + top.page + top.size / Flash.BYTES_PER_PAGE);
        delete();
        size = length;
        createNewFile();
    }

    /**
     * Says that it is no folder.
     *
     * @hidden
     */
    public boolean isDirectory() {
        return false;
    }

    /** Gives the name. */
    public String toString() {
        return name;
    }

    static void writeTable() throws IOException {
        known();
        place = 0;
        for (int index = 0; index < SIGN.length(); index++) write(SIGN.charAt(index));
        write(0);
        byte count = 0;
        try {
            while (count < MAX_FILES && files[count] != null) {
                files[count].writeEntry();
                count++;
            }
        } finally {
            Flash.writePage(buffer, TABLE_PAGE);
            Flash.readPage(buffer, TABLE_PAGE);
            buffer[SIGN.length()] = count;
            totalFiles = count;
            Flash.writePage(buffer, TABLE_PAGE);
        }
    }

    private void writeEntry() throws IOException {
        writeNumber(page, 2);
        writeNumber(size, 4);
        write(attributes);
        write(name.length());
        for (int index = 0; index < name.length(); index++) write(name.charAt(index));
    }

    private void moveTo(int target) throws IOException {
        int from = page;
        page = target;
        for (int count = pagesOf(size); count > 0; count--) {
            Flash.readPage(buffer, from++);
            Flash.writePage(buffer, target++);
        }
        writeTable();
    }

    private static File[] known() {
        if (files != null) return files;
        files = new File[MAX_FILES];
        if (!hasTable()) {
            format();
            files = new File[MAX_FILES];
        }
        Flash.readPage(buffer, TABLE_PAGE);
        place = SIGN.length();
        totalFiles = (byte) read();
        for (int index = 0; index < totalFiles; index++) {
            int page = readNumber(2);
            int size = readNumber(4);
            int attributes = read();
            char[] name = new char[LONGEST_NAME];
            int length = read();
            for (int sign = 0; sign < length; sign++) name[sign] = (char) read();
            files[index] = new File(new String(name, 0, length), page, size, attributes);
        }
        return files;
    }

    private static boolean hasTable() {
        Flash.readPage(buffer, TABLE_PAGE);
        for (int index = 0; index < SIGN.length(); index++) {
            if (buffer[index] != SIGN.charAt(index)) return false;
        }
        return true;
    }

    private static int pagesOf(int bytes) {
        return (bytes + Flash.BYTES_PER_PAGE - 1) / Flash.BYTES_PER_PAGE;
    }

    private static int read() {
        return buffer[place++];
    }

    /** The lowest byte comes first. */
    private static int readNumber(int bytes) {
        int value = 0;
        for (int index = 0; index < bytes; index++) value |= (read() & 0xFF) << 8 * index;
        return value;
    }

    private static void write(int value) throws IOException {
        if (place >= Flash.BYTES_PER_PAGE) throw new IOException("File table is full. Try deleting some files.");
        buffer[place++] = (byte) value;
    }

    private static void writeNumber(int value, int bytes) throws IOException {
        for (int index = 0; index < bytes; index++) write(value >> 8 * index);
    }
}
