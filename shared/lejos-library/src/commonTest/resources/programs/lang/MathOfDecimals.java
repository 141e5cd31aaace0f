import josx.platform.rcx.LCD;

public class MathOfDecimals {
    static int thousands(double number) {
        return Math.round((float) number * 1000);
    }

    public static void main(String[] arguments) {
        LCD.showNumber(thousands(Math.sqrt(2))); // shows: 1414
        LCD.showNumber(thousands(Math.sqrt(9))); // shows: 3000
        LCD.showNumber(thousands(Math.sin(Math.PI / 6))); // shows: 500
        LCD.showNumber(thousands(Math.cos(Math.PI / 3))); // shows: 500
        LCD.showNumber(-thousands(Math.cos(Math.PI))); // shows: 1000
        LCD.showNumber(thousands(Math.tan(Math.PI / 4))); // shows: 1000
        LCD.showNumber(thousands(Math.asin(0.5))); // shows: 524
        LCD.showNumber(thousands(Math.acos(0.5))); // shows: 1047
        LCD.showNumber(thousands(Math.atan(1))); // shows: 785
        LCD.showNumber(thousands(Math.atan2(1, -1))); // shows: 2356
        LCD.showNumber(thousands(Math.exp(1))); // shows: 2718
        LCD.showNumber(thousands(Math.log(10))); // shows: 2303
        LCD.showNumber(thousands(Math.pow(2, 3))); // shows: 8000
        LCD.showNumber(thousands(Math.pow(2, -1))); // shows: 500
        LCD.showNumber(thousands(Math.pow(9, 0.5))); // shows: 3000
        LCD.showNumber(thousands(Math.toRadians(90))); // shows: 1571
        LCD.showNumber((int) Math.toDegrees(Math.PI)); // shows: 180
        LCD.showNumber(thousands(Math.E)); // shows: 2718
    }
}
