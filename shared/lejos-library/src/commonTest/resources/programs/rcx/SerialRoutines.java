import josx.platform.rcx.Serial;

public class SerialRoutines {
    public static void main(String[] arguments) throws InterruptedException {
        byte[] packet = {(byte) 0xF7, 5};
        Serial.setRangeLong(); // rom: 0x3250 0x1770
        Serial.setRangeShort(); // rom: 0x3266 0x1770
        Serial.setDataBuffer(new byte[20]); // rom: 0x327c 0x1771 ? 0
        Serial.isPacketAvailable(); // rom: 0x3426 ? ?
        Serial.readPacket(packet); // rom: 0x33b0 ? 2 ?
        Serial.sendPacket(packet, 0, 2); // rom: 0x343e 0x1775 0 ? 2
        Serial.waitTillSent();
        Serial.resetSerial();
    }
}
