import java.io.IOException;
import java.net.Socket;
import java.net.URL;
import josx.platform.rcx.LCD;
import josx.rcxcomm.RCXLNPAddressingPort;
import josx.rcxcomm.RCXLNPPort;

public class NoNetwork {
    static void reach(int kind) throws IOException {
        if (kind == 0) new Socket("example", 80);
        if (kind == 1) new URL("http://example").openConnection();
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
            }
        }
    }
}
