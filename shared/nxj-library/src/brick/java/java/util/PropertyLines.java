package java.util;

import java.io.IOException;
import java.io.InputStream;

/** The lines of a file of names and texts. */
class PropertyLines {
    private static final String BLANKS = " \t\f";
    private static final int LAST_SIGN = 126;

    private final InputStream in;

    PropertyLines(InputStream in) {
        this.in = in;
    }

    /** The next line that is no comment, without blanks before it, with the lines that go on from it; null at the end. */
    String next() throws IOException {
        StringBuilder line = new StringBuilder();
        boolean isInside = false;
        boolean isComment = false;
        while (true) {
            int read = in.read();
            boolean isEnd = read < 0 || read == '\n' || read == '\r';
            if (!isEnd) {
                if (!isInside && BLANKS.indexOf(read) >= 0) continue;
                if (line.length() == 0 && !isInside && (read == '#' || read == '!')) isComment = true;
                isInside = true;
                if (!isComment) line.append((char) read);
            } else if (!isComment && isContinued(line) && read >= 0) {
                line.setLength(line.length() - 1);
                isInside = false;
            } else if (line.length() > 0 || read < 0) {
                return line.length() == 0 ? null : line.toString();
            } else {
                isInside = false;
                isComment = false;
            }
        }
    }

    private static boolean isContinued(StringBuilder line) {
        int count = 0;
        while (count < line.length() && line.charAt(line.length() - 1 - count) == '\\') count++;
        return count % 2 == 1;
    }

    /** The place behind the name, where = or : or a blank stands that has no sign before it. */
    static int endOfName(String line) {
        for (int place = 0; place < line.length(); place++) {
            char sign = line.charAt(place);
            if (sign == '\\') {
                place++;
            } else if (sign == '=' || sign == ':' || BLANKS.indexOf(sign) >= 0) {
                return place;
            }
        }
        return line.length();
    }

    static String valueBehind(String line, int end) {
        boolean hasSign = false;
        int place = end;
        for (; place < line.length(); place++) {
            char sign = line.charAt(place);
            boolean isSign = sign == '=' || sign == ':';
            if (isSign && hasSign || !isSign && BLANKS.indexOf(sign) < 0) break;
            hasSign |= isSign;
        }
        return line.substring(place);
    }

    /** Signs as they are meant, such as a tab for backslash t. */
    static String plain(String text) {
        StringBuilder plain = new StringBuilder(text.length());
        for (int place = 0; place < text.length(); place++) {
            char sign = text.charAt(place);
            if (sign == '\\' && place + 1 < text.length()) {
                sign = text.charAt(++place);
                if (sign == 'u') {
                    if (place + 4 >= text.length()) throw new IllegalArgumentException();
                    sign = (char) Integer.parseInt(text.substring(place + 1, place + 5), 16);
                    place += 4;
                } else {
                    int known = "trnf".indexOf(sign);
                    if (known >= 0) sign = "\t\r\n\f".charAt(known);
                }
            }
            plain.append(sign);
        }
        return plain.toString();
    }

    /** The other way round; in a name, blanks have a sign before them, too. */
    static String escaped(String text, boolean isName) {
        StringBuilder escaped = new StringBuilder(text.length());
        for (int place = 0; place < text.length(); place++) {
            char sign = text.charAt(place);
            int known = "\t\r\n\f".indexOf(sign);
            if (known >= 0) {
                escaped.append('\\').append("trnf".charAt(known));
            } else if (sign < ' ' || sign > LAST_SIGN) {
                escaped.append("\\u");
                for (int shift = 12; shift >= 0; shift -= 4) {
                    escaped.append("0123456789ABCDEF".charAt(sign >> shift & 0xF));
                }
            } else {
                boolean isSpecial = "\\=:#!".indexOf(sign) >= 0 || sign == ' ' && (isName || place == 0);
                if (isSpecial) escaped.append('\\');
                escaped.append(sign);
            }
        }
        return escaped.toString();
    }
}
