public class Decisions {
    static int calls = 0;

    static boolean yes() {
        calls++;
        return true;
    }

    static int grade(int points) {
        if (points >= 90) {
            return 1;
        } else if (points >= 50) {
            return 3;
        } else {
            return 6;
        }
    }

    public static void main(String[] arguments) {
        System.out.println(grade(95)); // expect 1
        System.out.println(grade(50)); // expect 3
        System.out.println(grade(-1)); // expect 6
        boolean result = false && yes();
        System.out.println(calls); // expect 0
        result = true || yes();
        System.out.println(calls); // expect 0
        result = false & yes() | yes();
        System.out.println(calls); // expect 2
        System.out.println(result ? 7 : 8); // expect 7
        System.out.println(!result ^ true ? 7 : 8); // expect 7
    }
}
