import josx.platform.rcx.LCD;

public class MathRoundsLikeABrick {
    static double two = 2;

    public static void main(String[] arguments) {
        LCD.showNumber(-Math.round(-1.5f)); // shows: 2
        LCD.showNumber(-Math.round(-3.5f)); // shows: 4
        LCD.showNumber(-Math.round(-3.4f)); // shows: 3
        LCD.showNumber(Math.round(-0.5f)); // shows: 0
        LCD.showNumber(Math.round(0.5f)); // shows: 1
        LCD.showNumber(-(int) Math.floor(-two)); // shows: 3
        LCD.showNumber((int) Math.floor(two)); // shows: 2
        LCD.showNumber((int) Math.ceil(two)); // shows: 3
        LCD.showNumber(-(int) Math.ceil(-two)); // shows: 2
        LCD.showNumber(Math.floor(-1.0e9) == -1.0e9 && Math.ceil(1.0e9) == 1.0e9 ? 1 : 0); // shows: 1
    }
}
