import java.io.IOException;
import josx.platform.rcx.LCD;
import josx.rcxcomm.LLCHandler;
import josx.rcxcomm.LLCReliableHandler;
import josx.rcxcomm.LNP;
import josx.rcxcomm.RCXOutputStream;

/** Sends numbers in three ways to HearsOnTheAir on another brick; alone, nobody answers. */
public class TalksOnTheAir extends Thread {
    static void sleepUntil(int time) throws InterruptedException {
        int rest = time - (int) System.currentTimeMillis();
        if (rest > 0) Thread.sleep(rest);
    }

    /** Waits for answers, for ever if there are none. */
    public void run() {
        LLCReliableHandler handler = new LLCReliableHandler(new LLCHandler());
        handler.sendPacket(new byte[] {2}, 1);
        handler.sendPacket(new byte[] {10}, 1);
    }

    public static void main(String[] arguments) throws InterruptedException {
        sleepUntil(200);
        int answered = 1;
        try {
            new RCXOutputStream().write(1);
        } catch (IOException nobody) {
            answered = 0;
        }
        sleepUntil(2500);
        Thread reliable = new TalksOnTheAir();
        reliable.setDaemon(true);
        reliable.setPriority(MIN_PRIORITY);
        reliable.start();
        sleepUntil(4900);
        if (!reliable.isAlive()) answered += 2;
        sleepUntil(5500);
        LNP.integrityWrite(new byte[] {50, 100}, 2);
        sleepUntil(6500);
        LNP.addressingWrite(new byte[] {50, 60, 70, 80}, 4, (byte) 0x21, (byte) 0x10);
        sleepUntil(7000);
        LNP.addressingWrite(new byte[] {90}, 1, (byte) 0x31, (byte) 0x10);
        LCD.showNumber(answered); // shows: 0
    }
}
