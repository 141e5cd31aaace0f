package java.util;

import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;

/** Texts with names, which can be kept in a file. */
public class Properties extends Hashtable<String, String> {
    /** Where a name is looked for that is not here, or null. */
    protected Properties defaults;

    /** Makes an empty one. */
    public Properties() {
    }

    /** Makes an empty one, which looks for missing names in the other one. */
    public Properties(Properties defaults) {
        this.defaults = defaults;
    }

    /** Gives the text with the name, or null if there is none. */
    public String getProperty(String name) {
        String text = get(name);
        return text == null && defaults != null ? defaults.getProperty(name) : text;
    }

    /** Gives the text with the name, or the other one if there is none. */
    public String getProperty(String name, String otherwise) {
        String text = getProperty(name);
        return text == null ? otherwise : text;
    }

    /** Sets the text with the name, and gives the one before, or null. */
    public Object setProperty(String name, String text) {
        return put(name, text);
    }

    /** Reads lines such as "name=text". */
    public void load(InputStream in) throws IOException {
        StringBuilder line = new StringBuilder();
        int read;
        do {
            read = in.read();
            if (read >= 0 && read != '\n') {
                if (read != '\r') line.append((char) read);
            } else {
                add(line.toString().trim());
                line.setLength(0);
            }
        } while (read >= 0);
    }

    /** Writes all names and texts as lines. */
    public void store(OutputStream out, String comment) throws IOException {
        if (comment != null) write(out, "#" + comment);
        for (Enumeration<String> names = keys(); names.hasMoreElements();) {
            String name = names.nextElement();
            write(out, name + "=" + get(name));
        }
        out.flush();
    }

    private void add(String line) {
        if (line.length() == 0 || line.charAt(0) == '#' || line.charAt(0) == '!') return;
        int equals = line.indexOf('=');
        if (equals < 0) {
            put(line, "");
        } else {
            put(line.substring(0, equals).trim(), line.substring(equals + 1).trim());
        }
    }

    private static void write(OutputStream out, String line) throws IOException {
        out.write(line.getBytes());
        out.write('\n');
    }
}
