package java.net;

import java.io.IOException;

/** The address of something on the internet, which a brick in Robotran cannot reach. */
public class URL {
    private static final int HTTP_PORT = 80;

    /** How many characters "://" has. */
    private static final int BEFORE_HOST = 3;

    private final String host;
    private final String path;

    /** Makes one of a text such as "http://lejos.org/index.html"; fails if it has no colon, no host or no path. */
    public URL(String text) throws MalformedURLException {
        char[] characters = text.toCharArray();
        int colon = placeOf(':', characters, 0);
        int hostPlace = colon + BEFORE_HOST;
        int pathPlace = placeOf('/', characters, hostPlace);
        if (pathPlace >= characters.length) throw new MalformedURLException();
        host = new String(characters, hostPlace, pathPlace - hostPlace);
        path = new String(characters, pathPlace, characters.length - pathPlace);
    }

    /** Asks for what is at the address; fails, because this brick has no network. */
    public URLConnection openConnection() throws IOException {
        return new URLConnection(host, HTTP_PORT, path);
    }

    /** The place of a character from a place on, or the number of characters if it is not there. */
    private static int placeOf(char wanted, char[] characters, int first) {
        int place = first;
        while (place < characters.length && characters[place] != wanted) place++;
        return place;
    }
}
