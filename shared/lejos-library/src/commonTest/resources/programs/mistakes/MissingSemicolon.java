import josx.platform.rcx.Motor;

public class MissingSemicolon {
    public static void main(String[] arguments) {
        Motor.A.forward()
        Motor.C.forward();
    }
}
// error 5
