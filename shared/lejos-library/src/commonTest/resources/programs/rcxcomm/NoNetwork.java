import java.io.IOException;
import java.net.MalformedURLException;
import java.net.Socket;
import java.net.URL;
import java.net.URLConnection;
import josx.platform.rcx.LCD;

public class NoNetwork {
    static void talk(String host) throws IOException {
        Socket socket = new Socket(host, 80);
        socket.getOutputStream().write(1);
        socket.getInputStream().read();
        socket.close();
    }

    static void read(URLConnection connection) throws IOException {
        connection.getOutputStream().write(1);
        connection.getInputStream().read();
    }

    static void reach(int kind) throws IOException {
        if (kind == 0) talk("example");
        if (kind == 1) read(new URL("http://example/page").openConnection());
        if (kind == 2) read(new URLConnection("example", 80, "/"));
    }

    static boolean isAddress(String text) {
        try {
            new URL(text);
            return true;
        } catch (MalformedURLException wrong) {
            return false;
        }
    }

    public static void main(String[] arguments) {
        for (int kind = 0; kind < 3; kind++) {
            try {
                reach(kind);
                LCD.showNumber(99);
            } catch (IOException noWay) {
                LCD.showNumber(kind); // shows: 0 1 2
                LCD.showNumber(noWay.getMessage().length()); // shows: 26 26 26
            }
        }
        LCD.showNumber(isAddress("http://example/") ? 1 : 0); // shows: 1
        LCD.showNumber(isAddress("http://example") ? 1 : 0); // shows: 0
        LCD.showNumber(isAddress("http:") ? 1 : 0); // shows: 0
        LCD.showNumber(isAddress("example") ? 1 : 0); // shows: 0
    }
}
