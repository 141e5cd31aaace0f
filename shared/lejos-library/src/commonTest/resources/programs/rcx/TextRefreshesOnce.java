import josx.platform.rcx.TextLCD;

public class TextRefreshesOnce {
    public static void main(String[] arguments) {
        TextLCD.print("A"); // rom: 0x27c8
    }
}
