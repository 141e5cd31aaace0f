import java.io.IOException;
import josx.platform.rcx.LCD;
import josx.rcxcomm.RCXInputStream;
import josx.rcxcomm.RCXOutputStream;

public class Streams {
    /** Sends a byte again and again, because nobody answers. */
    static class Writer extends Thread {
        Writer() {
            setDaemon(true);
        }

        public void run() {
            try {
                new RCXOutputStream().write(65);
            } catch (IOException never) {
                LCD.showNumber(9);
            }
        }
    }

    public static void main(String[] arguments) throws IOException, InterruptedException {
        LCD.showNumber(RCXInputStream.DEFAULT_BUFFER_SIZE); // shows: 32
        LCD.showNumber(RCXInputStream.DEFAULT_TIMEOUT); // shows: 0
        RCXInputStream in = new RCXInputStream();
        in.setTimeOut(200);
        LCD.showNumber(in.available()); // shows: 0
        int began = (int) System.currentTimeMillis();
        try {
            in.read();
        } catch (IOException nobodyIsThere) {
            int waited = (int) System.currentTimeMillis() - began;
            LCD.showNumber(waited >= 200 && waited < 300 ? 1 : 0); // shows: 1
        }
        in.close();
        Writer writer = new Writer();
        writer.start();
        Thread.sleep(1200);
        LCD.showNumber(writer.isAlive() ? 2 : 0); // shows: 2
    }
}
