import josx.platform.rcx.Button;

public class ButtonCallsTheRom {
    public static void main(String[] arguments) {
        Button.PRGM.isPressed(); // rom: 0x1fb6 0x3000 ?
        Button.readButtons(); // rom: 0x1fb6 0x3000 ?
    }
}
