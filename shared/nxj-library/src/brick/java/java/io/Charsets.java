package java.io;

/** The ways of writing characters as bytes that a brick knows by their names. */
class Charsets {
    private Charsets() {
    }

    /** Whether characters above 127 take several bytes; fails for a way that a brick does not know. */
    static boolean isUtf8(String name) throws UnsupportedEncodingException {
        String known = name.toLowerCase();
        if (known.equals("utf-8") || known.equals("utf8")) return true;
        boolean isByte = known.equals("iso-8859-1") || known.equals("latin1") || known.equals("us-ascii")
            || known.equals("ascii");
        if (!isByte) throw new UnsupportedEncodingException(name);
        return false;
    }
}
