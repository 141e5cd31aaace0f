import java.io.IOException;
import josx.platform.rcx.LCD;
import josx.rcxcomm.LLC;
import josx.rcxcomm.RCXF7Port;
import josx.rcxcomm.RCXPort;

public class Ports {
    /** Sends a byte again and again, because nobody answers. */
    static class Writer extends Thread {
        private final RCXPort port;

        Writer(RCXPort port) {
            this.port = port;
            setDaemon(true);
        }

        public void run() {
            try {
                port.getOutputStream().write(65);
            } catch (IOException never) {
                LCD.showNumber(9);
            }
        }
    }

    public static void main(String[] arguments) throws IOException, InterruptedException {
        RCXPort port = new RCXPort();
        port.setTimeOut(100);
        LCD.showNumber(port.getTimeOut()); // shows: 100
        LCD.showNumber(port.getInputStream().available()); // shows: 0
        try {
            port.getInputStream().read();
        } catch (IOException nobodyIsThere) {
            LCD.showNumber(1); // shows: 1
        }
        Writer writer = new Writer(port);
        writer.start();
        Thread.sleep(1200);
        LCD.showNumber(writer.isAlive() ? 2 : 0); // shows: 2
        port.reset();
        port.close();
        new RCXF7Port().close();
        LLC.init();
        LCD.showNumber(-LLC.read()); // shows: 1
        LCD.showNumber(-LLC.receive()); // shows: 1
    }
}
