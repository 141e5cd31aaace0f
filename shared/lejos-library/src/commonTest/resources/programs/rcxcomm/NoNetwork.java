import java.io.IOException;
import java.net.Socket;
import java.net.URL;
import java.net.URLConnection;
import josx.platform.rcx.LCD;
import josx.rcxcomm.RCXLNPAddressingPort;
import josx.rcxcomm.RCXLNPPort;

public class NoNetwork {
    static void talk(String host) throws IOException {
        Socket socket = new Socket(host, 80);
        socket.getOutputStream().write(1);
        socket.getInputStream().read();
        socket.close();
    }

    static void read(URL address) throws IOException {
        LCD.showNumber(address.toString().length()); // shows: 14
        URLConnection connection = address.openConnection();
        connection.getOutputStream().write(1);
        connection.getInputStream().read();
    }

    static void reach(int kind) throws IOException {
        if (kind == 0) talk("example");
        if (kind == 1) read(new URL("http://example"));
        if (kind == 2) new RCXLNPPort();
        if (kind == 3) new RCXLNPAddressingPort((byte) 1, (byte) 2);
    }

    public static void main(String[] arguments) {
        for (int kind = 0; kind < 4; kind++) {
            try {
                reach(kind);
                LCD.showNumber(99);
            } catch (IOException noWay) {
                LCD.showNumber(kind); // shows: 0 1 2 3
                LCD.showNumber(noWay.getMessage().length()); // shows: 26 26 42 42
            }
        }
    }
}
