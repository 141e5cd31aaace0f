package java.io;

/** Writes texts and numbers as people read them. */
public class PrintStream extends OutputStream {
    private final OutputStream out;

    /** Makes one that writes to the stream. */
    public PrintStream(OutputStream out) {
        this.out = out;
    }

    /** Writes a byte: the lowest eight bits of the number. */
    public void write(int value) {
        try {
            out.write(value);
        } catch (IOException ignored) {
            // Whoever prints does not want to hear of it.
        }
    }

    /** Writes what was kept back. */
    public void flush() {
        try {
            out.flush();
        } catch (IOException ignored) {
            // Whoever prints does not want to hear of it.
        }
    }

    /** Writes true or false. */
    public void print(boolean value) {
        print(String.valueOf(value));
    }

    /** Writes a character. */
    public void print(char value) {
        print(String.valueOf(value));
    }

    /** Writes a number. */
    public void print(int value) {
        print(String.valueOf(value));
    }

    /** Writes a number. */
    public void print(long value) {
        print(String.valueOf(value));
    }

    /** Writes a number. */
    public void print(float value) {
        print(String.valueOf(value));
    }

    /** Writes a number. */
    public void print(double value) {
        print(String.valueOf(value));
    }

    /** Writes characters. */
    public void print(char[] characters) {
        print(String.valueOf(characters));
    }

    /** Writes a text. */
    public synchronized void print(String text) {
        String shown = String.valueOf((Object) text);
        for (int index = 0; index < shown.length(); index++) write(shown.charAt(index));
    }

    /** Writes an object as text. */
    public void print(Object object) {
        print(String.valueOf(object));
    }

    /** Begins a new line. */
    public synchronized void println() {
        write('\n');
        flush();
    }

    /** Writes true or false, and begins a new line. */
    public void println(boolean value) {
        println(String.valueOf(value));
    }

    /** Writes a character, and begins a new line. */
    public void println(char value) {
        println(String.valueOf(value));
    }

    /** Writes a number, and begins a new line. */
    public void println(int value) {
        println(String.valueOf(value));
    }

    /** Writes a number, and begins a new line. */
    public void println(long value) {
        println(String.valueOf(value));
    }

    /** Writes a number, and begins a new line. */
    public void println(float value) {
        println(String.valueOf(value));
    }

    /** Writes a number, and begins a new line. */
    public void println(double value) {
        println(String.valueOf(value));
    }

    /** Writes characters, and begins a new line. */
    public void println(char[] characters) {
        println(String.valueOf(characters));
    }

    /** Writes a text, and begins a new line. */
    public synchronized void println(String text) {
        print(text);
        println();
    }

    /** Writes an object as text, and begins a new line. */
    public void println(Object object) {
        println(String.valueOf(object));
    }
}
