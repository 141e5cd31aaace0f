import java.io.IOException;
import josx.platform.rcx.LCD;
import josx.rcxcomm.F7DeliveryHandler;
import josx.rcxcomm.F7Handler;
import josx.rcxcomm.PacketHandler;
import josx.rcxcomm.RCXAbstractPort;

public class Handlers {
    /** What is sent comes back. */
    static class Echo extends PacketHandler {
        private byte value;
        private boolean isThere;

        public boolean sendPacket(byte[] packet, int length) {
            value = packet[0];
            isThere = true;
            return true;
        }

        public int receivePacket(byte[] buffer) {
            buffer[0] = value;
            isThere = false;
            return 1;
        }

        public boolean isPacketAvailable() {
            return isThere;
        }
    }

    /** The other brick that answers everything. */
    static class Answering extends Echo {
        public boolean sendPacket(byte[] packet, int length) {
            byte[] answer = {(byte) ~packet[0]};
            return super.sendPacket(answer, length);
        }
    }

    /** Hands on what the handler below it has. */
    static class Upper extends PacketHandler {
        Upper(PacketHandler below) {
            super(below);
        }

        public boolean sendPacket(byte[] packet, int length) {
            return lowerHandler.sendPacket(packet, length);
        }

        public int receivePacket(byte[] buffer) {
            return lowerHandler.receivePacket(buffer);
        }

        public boolean isPacketAvailable() {
            return lowerHandler.isPacketAvailable();
        }
    }

    static class Port extends RCXAbstractPort {
        Port(PacketHandler handler) throws IOException {
            super(handler);
        }
    }

    public static void main(String[] arguments) throws IOException {
        byte[] buffer = {9};
        PacketHandler plain = new Echo();
        plain.open((byte) 1, (byte) 2);
        plain.setListen(true);
        plain.reset();
        plain.close();
        LCD.showNumber(plain.getError() + plain.receiveAck(buffer)); // shows: 0
        LCD.showNumber(plain.isAckAvailable() ? 1 : 0); // shows: 0
        F7DeliveryHandler sure = new F7DeliveryHandler(new Answering());
        LCD.showNumber(sure.sendPacket(buffer, 1) ? 1 : 0); // shows: 1
        LCD.showNumber(sure.receivePacket(buffer)); // shows: 0
        LCD.showNumber(sure.isPacketAvailable() ? 1 : 0); // shows: 0
        F7Handler light = new F7Handler();
        LCD.showNumber(light.sendPacket(buffer, 1) ? 1 : 0); // shows: 1
        LCD.showNumber(light.isPacketAvailable() ? 1 : 0); // shows: 0
        LCD.showNumber(light.receivePacket(buffer)); // shows: 0
        PacketHandler upper = new Upper(new Echo());
        upper.open((byte) 1, (byte) 2);
        upper.reset();
        upper.close();
        LCD.showNumber(upper.sendPacket(buffer, 1) && upper.isPacketAvailable() ? upper.getError() : 9); // shows: 0
        RCXAbstractPort port = new Port(new Echo());
        port.getOutputStream().write(200);
        LCD.showNumber(port.getInputStream().read()); // shows: 200
        port.close();
    }
}
