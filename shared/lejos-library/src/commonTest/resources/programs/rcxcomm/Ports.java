import java.io.IOException;
import josx.platform.rcx.LCD;
import josx.rcxcomm.LLC;
import josx.rcxcomm.RCXF7Port;
import josx.rcxcomm.RCXPort;

public class Ports {
    public static void main(String[] arguments) throws IOException {
        RCXPort port = new RCXPort();
        port.setTimeOut(100);
        LCD.showNumber(port.getTimeOut()); // shows: 100
        LCD.showNumber(port.getInputStream().available()); // shows: 0
        try {
            port.getInputStream().read();
        } catch (IOException nobodyIsThere) {
            LCD.showNumber(1); // shows: 1
        }
        try {
            port.getOutputStream().write(65);
        } catch (IOException nobodyAnswers) {
            LCD.showNumber(2); // shows: 2
        }
        port.reset();
        port.close();
        new RCXF7Port().close();
        LLC.init();
        LCD.showNumber(-LLC.read()); // shows: 1
        LCD.showNumber(-LLC.receive()); // shows: 1
    }
}
