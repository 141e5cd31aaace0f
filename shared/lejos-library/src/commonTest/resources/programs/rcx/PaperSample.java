import josx.platform.rcx.Motor;

public class PaperSample {
    public static void main(String[] arguments) {
        Motor.A.forward(); // rom: 0x1a4e 0x2000 1 3
        Motor.C.forward(); // rom: 0x1a4e 0x2002 1 3
    }
}
// ends at 0
