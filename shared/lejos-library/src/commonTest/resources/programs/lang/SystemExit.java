import josx.platform.rcx.LCD;
import josx.platform.rcx.Motor;

public class SystemExit {
    public static void main(String[] arguments) {
        try {
            Motor.A.forward(); // rom: 0x1a4e 0x2000 1 3
            System.exit(0);
        } finally {
            LCD.showNumber(1);
        }
    }
}
// ends at 0
