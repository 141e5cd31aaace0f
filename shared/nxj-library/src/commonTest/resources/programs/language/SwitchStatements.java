public class SwitchStatements {
    static String name(int number) {
        switch (number) {
            case 0:
                return "zero";
            case 1:
            case 2:
                return "few";
            case 100000:
                return "many";
            case -5:
                return "minus";
            default:
                return "some";
        }
    }

    static int fall(char letter) {
        int result = 0;
        switch (letter) {
            case 'a':
                result += 1;
            case 'b':
                result += 10;
                break;
            default:
                result += 100;
            case 'c':
                result += 1000;
        }
        return result;
    }

    public static void main(String[] arguments) {
        int[] numbers = {0, 1, 2, 3, 100000, -5, 99999};
        for (int number : numbers) System.out.println(name(number)); // expect zero
        // expect few
        // expect few
        // expect some
        // expect many
        // expect minus
        // expect some
        for (char letter = 'a'; letter < 'e'; letter++) System.out.println(fall(letter)); // expect 11
        // expect 10
        // expect 1000
        // expect 1100
        int laps = 0;
        outer:
        for (int i = 0; i < 10; i++) {
            switch (i % 4) {
                case 3:
                    if (i > 6) break outer;
                    continue outer;
                case 0:
                    break;
                default:
                    laps++;
            }
            laps += 10;
        }
        System.out.println(laps); // expect 64
        byte small = 7;
        switch (small) {
        }
        switch (small) {
            case 7:
                int inner = 5;
                System.out.println(inner); // expect 5
        }
    }
}
