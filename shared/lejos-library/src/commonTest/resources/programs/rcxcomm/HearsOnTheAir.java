import java.io.IOException;
import josx.platform.rcx.LCD;
import josx.rcxcomm.AddressingHandler;
import josx.rcxcomm.F7DeliveryHandler;
import josx.rcxcomm.F7Handler;
import josx.rcxcomm.IntegrityHandler;
import josx.rcxcomm.LNP;
import josx.rcxcomm.RCXInputStream;

/** Adds up what TalksOnTheAir on another brick sends in three ways; alone, it hears nothing. */
public class HearsOnTheAir implements IntegrityHandler, AddressingHandler {
    static int sum = 0;

    static void rest() {
        try {
            Thread.sleep(10);
        } catch (InterruptedException never) {
            LCD.clear();
        }
    }

    static void hearMessages(int end) {
        F7DeliveryHandler handler = new F7DeliveryHandler(new F7Handler());
        byte[] buffer = new byte[1];
        while ((int) System.currentTimeMillis() < end) {
            if (handler.isPacketAvailable()) {
                handler.receivePacket(buffer);
                sum += buffer[0];
            }
            rest();
        }
    }

    static void hearStream(int end) {
        RCXInputStream in = new RCXInputStream();
        try {
            while (true) {
                in.setTimeOut(end - (int) System.currentTimeMillis());
                sum += in.read();
            }
        } catch (IOException nothingMore) {
            in.close();
        }
    }

    public void processIntegrityPacket(byte[] packet, int length) {
        sum += packet[length - 1];
    }

    public void processAddressingPacket(byte[] packet, int length, byte source) {
        sum += packet[length - 1] + source;
    }

    public static void main(String[] arguments) {
        hearMessages(2900);
        hearStream(5500);
        HearsOnTheAir ear = new HearsOnTheAir();
        LNP.addIntegrityHandler(ear);
        LNP.addAddressingHandler(ear, (byte) 1);
        LNP.startListening((byte) 0x20);
        while ((int) System.currentTimeMillis() < 8500) rest();
        LCD.showNumber(sum); // shows: 0
    }
}
// ends at 8500
