import java.io.IOException;
import josx.platform.rcx.LCD;
import josx.rcxcomm.F7DeliveryHandler;
import josx.rcxcomm.F7Handler;
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
        try {
            RCXOutputStream out = new RCXOutputStream();
            out.write(2);
            out.write(200);
        } catch (IOException never) {
            LCD.showNumber(9);
        }
    }

    public static void main(String[] arguments) throws InterruptedException {
        sleepUntil(200);
        int answered = new F7DeliveryHandler(new F7Handler()).sendPacket(new byte[] {1}, 1) ? 1 : 0;
        sleepUntil(3000);
        Thread stream = new TalksOnTheAir();
        stream.setDaemon(true);
        stream.setPriority(MIN_PRIORITY);
        stream.start();
        sleepUntil(5400);
        if (!stream.isAlive()) answered += 2;
        sleepUntil(6000);
        LNP.integrityWrite(new byte[] {50, 100}, 2);
        sleepUntil(7000);
        LNP.addressingWrite(new byte[] {50, 60, 70, 80}, 4, (byte) 0x21, (byte) 0x10);
        sleepUntil(7500);
        LNP.addressingWrite(new byte[] {90}, 1, (byte) 0x31, (byte) 0x10);
        LCD.showNumber(answered); // shows: 0
    }
}
