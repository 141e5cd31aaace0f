import josx.platform.rcx.LCD;

public class Arithmetic {
    public static void main(String[] arguments) {
        int a = 17;
        int b = -5;
        LCD.showNumber(a + b); // shows: 12
        LCD.showNumber(a - b); // shows: 22
        LCD.showNumber(a * -b); // shows: 85
        LCD.showNumber(-(a / b)); // shows: 3
        LCD.showNumber(a % b); // shows: 2
        LCD.showNumber(-(-a % b)); // shows: 2
        a += 3;
        a -= 1;
        a *= 2;
        a /= 3;
        a %= 7;
        LCD.showNumber(a++); // shows: 5
        LCD.showNumber(++a); // shows: 7
        LCD.showNumber(--a - a--); // shows: 0
        LCD.showNumber(Integer.MAX_VALUE + 1 == Integer.MIN_VALUE ? 1 : 0); // shows: 1
    }
}
