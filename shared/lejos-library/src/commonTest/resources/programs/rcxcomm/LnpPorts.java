import java.io.IOException;
import josx.platform.rcx.LCD;
import josx.rcxcomm.RCXAbstractPort;
import josx.rcxcomm.RCXLNPAddressingPort;
import josx.rcxcomm.RCXLNPPort;

public class LnpPorts {
    static void talk(RCXAbstractPort port) throws IOException {
        port.setTimeOut(50);
        port.getOutputStream().write(65); // nobody answers, so that this works though nobody is there
        try {
            port.getInputStream().read();
        } catch (IOException nobodyIsThere) {
            LCD.showNumber(port.getTimeOut()); // shows: 50 50
        }
        port.close();
    }

    public static void main(String[] arguments) throws IOException {
        talk(new RCXLNPPort());
        talk(new RCXLNPAddressingPort((byte) 0x10, (byte) 0x20));
    }
}
