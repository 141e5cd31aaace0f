import josx.platform.rcx.Motor;

public class WrongType {
    public static void main(String[] arguments) {
        int power = 2.5f;
        Motor.A.setPower("fast");
        Motor.D.forward();
        Motor.A.forwards();
        undeclared = 1;
    }
}
// error 5
// error 6
// error 7
// error 8
// error 9
