import josx.platform.rcx.LCD;
import josx.rcxcomm.LLCReliableHandler;
import josx.rcxcomm.PacketHandler;

public class ReliableHandlers {
    /** What one end sends comes out at the other, but some packets are lost on the way. */
    static class Wire extends PacketHandler {
        private final byte[] packet = new byte[3];
        private final byte[] answer = new byte[2];
        private Wire other;
        private boolean hasPacket;
        private boolean hasAnswer;
        private int toLose;
        private int sent;

        static Wire[] pair() {
            Wire[] ends = {new Wire(), new Wire()};
            ends[0].other = ends[1];
            ends[1].other = ends[0];
            return ends;
        }

        public synchronized boolean sendPacket(byte[] bytes, int length) {
            sent++;
            if (toLose-- > 0) return true;
            if (length == 2) {
                other.answer[0] = bytes[0];
                other.answer[1] = bytes[1];
                other.hasAnswer = true;
            } else {
                for (int index = 0; index < length; index++) other.packet[index] = bytes[index];
                other.hasPacket = true;
            }
            return true;
        }

        public int receivePacket(byte[] buffer) {
            hasPacket = false;
            for (int index = 0; index < packet.length; index++) buffer[index] = packet[index];
            return packet.length;
        }

        public int receiveAck(byte[] buffer) {
            hasAnswer = false;
            buffer[0] = answer[0];
            buffer[1] = answer[1];
            return answer.length;
        }

        public boolean isPacketAvailable() {
            return hasPacket;
        }

        public boolean isAckAvailable() {
            return hasAnswer;
        }
    }

    static class Listener extends Thread {
        private final LLCReliableHandler handler;

        Listener(PacketHandler wire) {
            handler = new LLCReliableHandler(wire);
            setDaemon(true);
        }

        public void run() {
            byte[] buffer = new byte[1];
            while (true) {
                while (handler.isPacketAvailable()) {
                    LCD.showNumber(handler.receivePacket(buffer) * 100 + buffer[0]); // shows: 165 166 167
                }
                try {
                    sleep(10);
                } catch (InterruptedException never) {
                    return;
                }
            }
        }
    }

    public static void main(String[] arguments) throws InterruptedException {
        Wire[] ends = Wire.pair();
        new Listener(ends[1]).start();
        LLCReliableHandler talker = new LLCReliableHandler(ends[0]);
        byte[] letter = {65};
        talker.sendPacket(letter, 1);
        letter[0]++;
        ends[0].toLose = 2; // the packet is sent three times
        talker.sendPacket(letter, 1);
        letter[0]++;
        ends[1].toLose = 1; // the answer is lost, so the packet comes twice and counts once
        talker.sendPacket(letter, 1);
        LCD.showNumber(ends[0].sent * 10 + ends[1].sent); // shows: 64
        byte[] damaged = {(byte) 0xF8, 68, 0};
        ends[0].sendPacket(damaged, 3);
        Thread.sleep(50);
        LCD.showNumber(ends[1].sent); // shows: 4
        talker.reset();
        talker.sendPacket(letter, 1);
        LCD.showNumber(ends[1].sent); // shows: 5
    }
}
