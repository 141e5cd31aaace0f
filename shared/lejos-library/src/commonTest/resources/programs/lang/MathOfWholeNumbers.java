import josx.platform.rcx.LCD;

public class MathOfWholeNumbers {
    public static void main(String[] arguments) {
        LCD.showNumber(Math.abs(-3)); // shows: 3
        LCD.showNumber(Math.min(4, -2) + 10); // shows: 8
        LCD.showNumber(Math.max(4, -2)); // shows: 4
        LCD.showNumber(Math.round(2.5f)); // shows: 3
        LCD.showNumber(-Math.round(-2.5f)); // shows: 3
        LCD.showNumber(-Math.round(-2.6f)); // shows: 3
        LCD.showNumber((int) Math.floor(2.9)); // shows: 2
        LCD.showNumber(-(int) Math.floor(-2.1)); // shows: 3
        LCD.showNumber((int) Math.ceil(2.1)); // shows: 3
        LCD.showNumber(-(int) Math.ceil(-2.9)); // shows: 2
        LCD.showNumber((int) (Math.abs(-2.5) * 10)); // shows: 25
        LCD.showNumber((int) (Math.min(2.5, 3.5) * 10)); // shows: 25
        LCD.showNumber((int) (Math.max(2.5, 3.5) * 10)); // shows: 35
        float chance = (float) Math.random();
        LCD.showNumber(chance >= 0 && chance < 1 ? 1 : 0); // shows: 1
    }
}
