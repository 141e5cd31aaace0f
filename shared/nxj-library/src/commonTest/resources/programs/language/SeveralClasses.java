class Numbers {
    static int number = 11;

    static int doubled() {
        return Doubler.twice(number);
    }
}

class Doubler {
    static int twice(int number) {
        return number * 2;
    }
}

public class SeveralClasses {
    public static void main(String[] arguments) {
        System.out.println(Numbers.doubled()); // expect 22
    }
}
