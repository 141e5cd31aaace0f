import josx.platform.rcx.ROM;

public class RomCalls {
    public static void main(String[] arguments) {
        ROM.call((short) 0x27c8); // rom: 0x27c8
        ROM.call((short) 0x1b62, (short) 0x3006); // rom: 0x1b62 0x3006
        ROM.call((short) 0x299a, (short) 0x4004, (short) 1); // rom: 0x299a 0x4004 1
        ROM.call((short) 0x1a4e, (short) 0x2001, (short) 2, (short) 7); // rom: 0x1a4e 0x2001 2 7
        ROM.call((short) 0x327c, (short) 0x1773, (short) 440, (short) 50, (short) 0); // rom: 0x327c 0x1773 440 50 0
    }
}
