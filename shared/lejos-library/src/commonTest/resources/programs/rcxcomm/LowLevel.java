import josx.rcxcomm.LLC;

public class LowLevel {
    public static void main(String[] arguments) {
        byte[] bytes = {1, 2, 3};
        LLC.init();
        LLC.setRangeLong(); // rom: 0x3250 0x1770
        LLC.setRangeShort(); // rom: 0x3266 0x1770
        if (!LLC.isSending() && !LLC.isSendError()) LLC.write(bytes, 3); // rom: 0x343e 0x1775 0 ? 3
        while (LLC.isSending()) Thread.yield();
        LLC.sendBytes(bytes, 2); // rom: 0x343e 0x1775 0 ? 2
    }
}
