package java.util;

import java.io.BufferedWriter;
import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.io.OutputStreamWriter;
import java.io.PrintStream;

/** Texts with names, which can be kept in a file. */
public class Properties extends Hashtable<Object, Object> {
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
        Object value = get(name);
        String text = value instanceof String ? (String) value : null;
        return text == null && defaults != null ? defaults.getProperty(name) : text;
    }

    /** Gives the text with the name, or the other one if there is none. */
    public String getProperty(String name, String otherwise) {
        String text = getProperty(name);
        return text == null ? otherwise : text;
    }

    /** Sets the text with the name. */
    public synchronized void setProperty(String name, String text) {
        put(name, text);
    }

    /** Gives all names, also those of the other one that it looks in. */
    public Enumeration<?> propertyNames() {
        return all().keys();
    }

    /** Writes all names and texts, one in a line; of long texts, only the beginning. */
    public void list(PrintStream out) {
        out.println("- properties -");
        Hashtable<Object, Object> all = all();
        for (Enumeration<Object> names = all.keys(); names.hasMoreElements();) {
            Object name = names.nextElement();
            String text = (String) all.get(name);
            if (text.length() > 40) text = text.substring(0, 37) + "...";
            out.println(name + "=" + text);
        }
    }

    /** Reads lines such as "name=text". */
    public synchronized void load(InputStream in) throws IOException {
        PropertyLines lines = new PropertyLines(in);
        for (String line = lines.next(); line != null; line = lines.next()) {
            int end = PropertyLines.endOfName(line);
            put(PropertyLines.plain(line.substring(0, end)), PropertyLines.plain(PropertyLines.valueBehind(line, end)));
        }
    }

    /** Writes all names and texts as lines. */
    public void store(OutputStream out, String comment) throws IOException {
        BufferedWriter lines = new BufferedWriter(new OutputStreamWriter(out));
        if (comment != null) {
            lines.write("#" + comment);
            lines.newLine();
        }
        for (Enumeration<Object> names = keys(); names.hasMoreElements();) {
            String name = (String) names.nextElement();
            String text = (String) get(name);
            lines.write(PropertyLines.escaped(name, true) + "=" + PropertyLines.escaped(text, false));
            lines.newLine();
        }
        lines.flush();
    }

    private Hashtable<Object, Object> all() {
        Hashtable<Object, Object> all = defaults == null ? new Hashtable<Object, Object>() : defaults.all();
        for (Enumeration<Object> names = keys(); names.hasMoreElements();) {
            Object name = names.nextElement();
            all.put(name, get(name));
        }
        return all;
    }
}
