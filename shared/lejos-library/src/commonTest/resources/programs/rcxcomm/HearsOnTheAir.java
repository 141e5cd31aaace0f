import java.io.IOException;
import josx.platform.rcx.LCD;
import josx.rcxcomm.AddressingHandler;
import josx.rcxcomm.IntegrityHandler;
import josx.rcxcomm.LLCHandler;
import josx.rcxcomm.LLCReliableHandler;
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

    static void hearStream(int end) {
        RCXInputStream in = new RCXInputStream();
        try {
            in.setTimeOut(end - (int) System.currentTimeMillis());
            sum += in.read();
        } catch (IOException nothing) {
            sum += 0;
        }
        in.close();
    }

    static void hearReliable(int end) {
        LLCReliableHandler handler = new LLCReliableHandler(new LLCHandler());
        byte[] buffer = new byte[1];
        while ((int) System.currentTimeMillis() < end) {
            if (handler.isPacketAvailable()) {
                handler.receivePacket(buffer);
                sum += buffer[0];
            }
            rest();
        }
    }

    public void processIntegrityPacket(byte[] packet, int length) {
        sum += packet[length - 1];
    }

    public void processAddressingPacket(byte[] packet, int length, byte source) {
        sum += packet[length - 1] + source;
    }

    public static void main(String[] arguments) {
        hearStream(2000);
        while ((int) System.currentTimeMillis() < 2000) rest();
        hearReliable(5000);
        HearsOnTheAir ear = new HearsOnTheAir();
        LNP.addIntegrityHandler(ear);
        LNP.addAddressingHandler(ear, (byte) 1);
        LNP.startListening((byte) 0x20);
        while ((int) System.currentTimeMillis() < 8000) rest();
        LCD.showNumber(sum); // shows: 0
    }
}
// ends at 8000
