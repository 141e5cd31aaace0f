import josx.rcxcomm.LLC;

/** Plain bytes need no routine of the ROM, but their range does. After the end, the firmware gives the infrared to the ROM again. */
public class RangeOfBytes {
    public static void main(String[] arguments) {
        LLC.init();
        LLC.setRangeLong(); // rom: 0x3250 0x1770
        LLC.sendBytes(new byte[] {1, 2}, 2);
        LLC.setRangeShort(); // rom: 0x3266 0x1770
    }
}
